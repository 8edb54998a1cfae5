function loadlibrary(library, header, option, alias)
% LOADLIBRARY  What Octave lacks of MATLAB, for the library of clubface alone: the files must be there.
if ~exist(library, 'file') || ~exist(header, 'file')
    error('%s or %s is missing', library, header);
end
if ~strcmp(option, 'alias') || ~strcmp(alias, 'libclubface')
    error('only the alias libclubface is known');
end
end
