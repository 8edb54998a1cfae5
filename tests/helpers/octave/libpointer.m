classdef libpointer < handle
    % LIBPOINTER  Memory that a function of a library writes to.
    properties
        Value
    end
    methods
        function self = libpointer(type, value)
            if ~strcmp(type, 'doublePtr') || ~isa(value, 'double')
                error('only pointers to numbers are known');
            end
            self.Value = value;
        end
    end
end
