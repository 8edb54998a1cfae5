function loaded = libisloaded(alias)
% LIBISLOADED  Whether a library is loaded: call_library has it.
loaded = false;
end
