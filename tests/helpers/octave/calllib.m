function result = calllib(alias, name, varargin)
% CALLLIB  Calls a function of the library of clubface; what it writes to the memory of a libpointer is there
% afterwards. An array that is no libpointer stays as it is, as in MATLAB.
assert(strcmp(alias, 'libclubface'));
pointers = cellfun(@(each) isa(each, 'libpointer'), varargin);
values = varargin;
for place = find(pointers)
    values{place} = varargin{place}.Value;
end
[result, written] = call_library(name, values{:});
for place = find(pointers)
    varargin{place}.Value = written{place};
end
end
