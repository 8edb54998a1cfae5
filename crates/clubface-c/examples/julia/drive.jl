# A shot from Julia: launch, derivatives, a batch on all cores and the carry, by ccall and without any package.
#
#     clubface export inputs driver --speed "105 mph" --model volumetric -o driver.csv
#     LD_LIBRARY_PATH=$HOME/clubface/lib julia drive.jl volumetric driver.csv

const libclubface = "libclubface"
const INPUTS, OUTPUTS, FLIGHT_INPUTS, FLIGHT_OUTPUTS = UInt32(0), UInt32(1), UInt32(2), UInt32(3)

count_of(columns) = Int(@ccall libclubface.clubface_count(columns::UInt32)::Csize_t)

"The place of a column by its name, counted from 1."
function place(columns, name)
    column = @ccall libclubface.clubface_column(columns::UInt32, name::Cstring)::Cptrdiff_t
    column < 0 && error("there is no column $name")
    return Int(column) + 1
end

"Free a result; an error of clubface becomes one of Julia. Return its text, the list of the shots without a launch."
function finish(result)
    reason = @ccall libclubface.clubface_error(result::Ptr{Cvoid})::Cstring
    message = reason == C_NULL ? nothing : unsafe_string(reason)
    rejected = unsafe_string(@ccall libclubface.clubface_text(result::Ptr{Cvoid})::Cstring)
    @ccall libclubface.clubface_free(result::Ptr{Cvoid})::Cvoid
    message === nothing || error(message)
    return rejected
end

"Inputs and parameters that `clubface export inputs` has written."
function read_shot(file)
    rows = [split(line, ',') for line in Iterators.drop(eachline(file), 1)]
    values(kind) = [parse(Float64, row[3]) for row in rows if row[1] == kind]
    return values("input"), values("parameter")
end

"Launches: a row a shot, as `inputs` has."
function launches(model, inputs::Matrix{Float64}, parameters::Vector{Float64})
    rows = size(inputs, 1)
    outputs = zeros(rows, count_of(OUTPUTS))
    finish(@ccall libclubface.clubface_launches(
        model::Cstring, inputs::Ptr{Cdouble}, parameters::Ptr{Cdouble}, rows::Csize_t, 0.0::Cdouble, 0::Csize_t,
        outputs::Ptr{Cdouble})::Ptr{Cvoid})
    return outputs
end

"One launch and its Jacobian: a row an output, by the inputs and then the parameters."
function sensitivity(model, inputs::Vector{Float64}, parameters::Vector{Float64})
    outputs = zeros(count_of(OUTPUTS))
    jacobian = zeros(length(inputs) + length(parameters), length(outputs))
    finish(@ccall libclubface.clubface_sensitivity(
        model::Cstring, inputs::Ptr{Cdouble}, parameters::Ptr{Cdouble}, 0.0::Cdouble, outputs::Ptr{Cdouble},
        jacobian::Ptr{Cdouble})::Ptr{Cvoid})
    return outputs, permutedims(jacobian)
end

"The flight outputs of a launch, in default air on a fairway."
function fly(inputs::Vector{Float64}, launch::Vector{Float64})
    flight = zeros(count_of(FLIGHT_INPUTS))
    @ccall libclubface.clubface_default_flight(flight::Ptr{Cdouble})::Cvoid
    for name in ("velocity_x", "velocity_y", "velocity_z", "spin_x", "spin_y", "spin_z")
        flight[place(FLIGHT_INPUTS, name)] = launch[place(OUTPUTS, name)]
    end
    for name in ("ball_mass", "ball_radius", "ball_inertia")
        flight[place(FLIGHT_INPUTS, name)] = inputs[place(INPUTS, name)]
    end
    flown = zeros(count_of(FLIGHT_OUTPUTS))
    finish(@ccall libclubface.clubface_flights(
        flight::Ptr{Cdouble}, 1::Csize_t, 1::Csize_t, flown::Ptr{Cdouble})::Ptr{Cvoid})
    return flown
end

function main(model, file)
    inputs, parameters = read_shot(file)
    launch, jacobian = sensitivity(model, inputs, parameters)
    speed, spin = place(OUTPUTS, "ball_speed"), place(OUTPUTS, "backspin")
    println("ball speed ", launch[speed], " m/s, backspin ", launch[spin] * 30 / pi, " rpm")
    println("a degree more loft: ", jacobian[spin, place(INPUTS, "loft")] * pi / 180 * 30 / pi, " rpm")
    println("carry ", fly(inputs, launch)[place(FLIGHT_OUTPUTS, "carry")], " m")

    shots = repeat(permutedims(inputs), 1000)
    shots[:, place(INPUTS, "toe")] = range(-0.03, 0.03, length = 1000)
    speeds = launches(model, shots, parameters)[:, speed]
    println("3 cm to the toe costs ", maximum(speeds) - speeds[end], " m/s")
end

if abspath(PROGRAM_FILE) == @__FILE__
    main(ARGS...)
end
