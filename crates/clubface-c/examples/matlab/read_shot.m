function [inputs, parameters, names] = read_shot(file)
% READ_SHOT  Inputs and parameters that "clubface export inputs" has written, as rows, and the names of the inputs.
handle = fopen(file);
cells = textscan(handle, '%s %s %f %s', 'Delimiter', ',', 'HeaderLines', 1);
fclose(handle);
is_input = strcmp(cells{1}, 'input');
inputs = cells{3}(is_input)';
parameters = cells{3}(~is_input)';
names = cells{2}(is_input)';
end
