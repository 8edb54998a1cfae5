function [launch, jacobian, carry] = drive(prefix, model, file)
% DRIVE  Launch, derivatives and carry of a shot by loadlibrary, without compiling anything of your own.
%   prefix is the folder that libclubface is installed in, the file is one of "clubface export inputs". launch has
%   a column an output of clubface, jacobian a row an output and a column an input or parameter.
here = fileparts(mfilename('fullpath'));
if ~libisloaded('libclubface')
    loadlibrary(fullfile(prefix, 'lib', 'libclubface.so'), fullfile(here, 'clubface_matlab.h'), 'alias', 'libclubface');
end
INPUTS = 0; OUTPUTS = 1; FLIGHT_INPUTS = 2; FLIGHT_OUTPUTS = 3;
[inputs, parameters] = read_shot(file);
width = double(calllib('libclubface', 'clubface_count', OUTPUTS));

launched = libpointer('doublePtr', zeros(1, width));
derivatives = libpointer('doublePtr', zeros(numel(inputs) + numel(parameters), width));
finish(calllib('libclubface', 'clubface_sensitivity', model, inputs, parameters, 0, launched, derivatives));
launch = launched.Value;
jacobian = derivatives.Value';

flight = libpointer('doublePtr', zeros(1, double(calllib('libclubface', 'clubface_count', FLIGHT_INPUTS))));
calllib('libclubface', 'clubface_default_flight', flight);
values = flight.Value;
for name = {'velocity_x', 'velocity_y', 'velocity_z', 'spin_x', 'spin_y', 'spin_z'}
    values(place(FLIGHT_INPUTS, name{1})) = launch(place(OUTPUTS, name{1}));
end
for name = {'ball_mass', 'ball_radius', 'ball_inertia'}
    values(place(FLIGHT_INPUTS, name{1})) = inputs(place(INPUTS, name{1}));
end
flown = libpointer('doublePtr', zeros(1, double(calllib('libclubface', 'clubface_count', FLIGHT_OUTPUTS))));
finish(calllib('libclubface', 'clubface_flights', values, 1, 1, flown));
carry = flown.Value(place(FLIGHT_OUTPUTS, 'carry'));
end

function index = place(columns, name)
% The place of a column, counted from 1.
index = double(calllib('libclubface', 'clubface_column', columns, name)) + 1;
end

function finish(result)
% Frees a result; an error of clubface becomes one of MATLAB.
message = calllib('libclubface', 'clubface_error', result);
calllib('libclubface', 'clubface_free', result);
if ~isempty(message)
    error('clubface:input', '%s', message);
end
end
