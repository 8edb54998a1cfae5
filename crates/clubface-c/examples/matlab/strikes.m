function [toe, loss, slopes] = strikes(model, file)
% STRIKES  What a thousand strikes from heel to toe cost in ball speed, and how their spin changes with loft and toe.
%   The file is one of "clubface export inputs". Needs the function that clubface_launch.c is compiled to. slopes is
%   strike by output by variable.
[shot, parameters, names] = read_shot(file);
toe = linspace(-0.03, 0.03, 1000)';
shots = repmat(shot, numel(toe), 1);
shots(:, strcmp(names, 'toe')) = toe;

speed = clubface_launch(model, shots, parameters, {'ball_speed'});
loss = max(speed) - speed;
[~, slopes] = clubface_launch(model, shots, parameters, {'backspin', 'sidespin'}, {'loft', 'toe'});
end
