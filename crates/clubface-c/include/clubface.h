/* clubface for C: how a golf club meets a ball. Made from the crate clubface-c by cbindgen; do not edit. */

#ifndef CLUBFACE_H
#define CLUBFACE_H

#include <stdarg.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>

/* Memory: every computing function returns a result that is never null and belongs to the caller, who ends it with
   clubface_free. What is read from it is valid until then. Arrays that go in or out belong to the caller; nothing is
   kept of them. Text is UTF-8 and ends with a null byte; descriptions, errors and rejected rows are JSON. All values
   are in SI units and radians. Functions may be called from several threads at once. */

// Number of this interface; it grows with every change that a compiled caller would notice.
#define CLUBFACE_ABI 2

// Numbers of a head.
#define CLUBFACE_HEAD HEAD

// Numbers of a ball.
#define CLUBFACE_BALL BODY

// Numbers of what acts between head and ball: force on the ball, whose opposite acts on the head (N), torque on the ball
// about its centre, torque on the head about its CG (N m), the point at which the force acts (m), each three; normal force
// (N), penetration (m, negative when apart) and its rate (m/s).
#define CLUBFACE_WRENCH WRENCH

// Numbers of motion that a wrench is differentiated by: position, small turn about the axes of the world (rad), velocity
// and angular velocity of the head; position, velocity and angular velocity of the ball.
#define CLUBFACE_MOTION MOTION

// Numbers of a step of a struck ball: mean force on the head (N) and mean torque on it about its CG (N m), each three,
// normal force (N) and penetration (m) at the end.
#define CLUBFACE_STEP 8

// Kind of the numbers of an array.
enum ClubfaceKind
#if defined(__cplusplus) || __STDC_VERSION__ >= 202311L
  : uint32_t
#endif // defined(__cplusplus) || __STDC_VERSION__ >= 202311L
 {
  // `double`.
  CLUBFACE_KIND_FLOAT64 = 0,
  // `float`.
  CLUBFACE_KIND_FLOAT32 = 1,
  // `uint32_t`.
  CLUBFACE_KIND_UINT32 = 2,
};
#ifndef __cplusplus
#if __STDC_VERSION__ >= 202311L
typedef enum ClubfaceKind ClubfaceKind;
#else
typedef uint32_t ClubfaceKind;
#endif // __STDC_VERSION__ >= 202311L
#endif // __cplusplus

// Columns that a caller lays out or takes.
enum ClubfaceColumns
#if defined(__cplusplus) || __STDC_VERSION__ >= 202311L
  : uint32_t
#endif // defined(__cplusplus) || __STDC_VERSION__ >= 202311L
 {
  // Inputs of an impact.
  CLUBFACE_COLUMNS_INPUTS = 0,
  // Outputs of an impact.
  CLUBFACE_COLUMNS_OUTPUTS = 1,
  // Inputs of a flight.
  CLUBFACE_COLUMNS_FLIGHT_INPUTS = 2,
  // Outputs of a flight.
  CLUBFACE_COLUMNS_FLIGHT_OUTPUTS = 3,
};
#ifndef __cplusplus
#if __STDC_VERSION__ >= 202311L
typedef enum ClubfaceColumns ClubfaceColumns;
#else
typedef uint32_t ClubfaceColumns;
#endif // __STDC_VERSION__ >= 202311L
#endif // __cplusplus

// A contact between a head and a ball that the caller moves. End it with [`clubface_contact_end`].
typedef struct ClubfaceContact ClubfaceContact;

// A result: an error, or text and arrays. End it with [`clubface_free`].
typedef struct ClubfaceResult ClubfaceResult;

// A ball that is moved through the contact with a head that the caller moves. End it with [`clubface_ball_end`].
typedef struct ClubfaceStruckBall ClubfaceStruckBall;

// A law of a material's change of shape, called for `count` points at once and by several threads at a time. Rows of
// `count` numbers, one of each point: `shapes`, the right Cauchy-Green tensor without its change of volume,
// `J^(-2/3) F^T F`, in the rows xx, yy, zz, xy, xz, yz; `states`, the state variables, zero before any deformation, which
// the function moves on by `step` seconds, in place; `results`, twice the derivative of the elastic energy by `shapes` (Pa)
// in such rows, apart from any multiple of the inverse of `shapes`, then the elastic energy (J/m3), then the energy that
// became heat so far (J/m3), zero unless written. `constants` are those of the material (SI).
typedef void (*ClubfaceLaw)(size_t count,
                            const double *shapes,
                            const double *constants,
                            double step,
                            double *states,
                            double *results);

// Called by a running simulation with the caller's pointer, the simulated time and the duration, s; `false` stops it.
typedef bool (*ClubfaceProgress)(void *context, double time, double duration);

#ifdef __cplusplus
extern "C" {
#endif // __cplusplus

// Returns the number of the interface of the library, to be compared with [`CLUBFACE_ABI`] of the header.
uint32_t clubface_abi(void);

// Returns the version of clubface, such as "0.1.0". The text lives as long as the program.
const char *clubface_version(void);

// Describes everything that can be computed, as text: `quantities`, `units`, `dimensions`, `models` with their
// parameters, and `inputs`, `outputs`, `flight_inputs`, `flight_outputs` in the order of the columns, `shot_shapes`.
// A number that is not finite, such as the default of an input that has none, is null.
ClubfaceResult *clubface_describe(void);

// Returns `bytes` of memory, aligned for every kind of number, for hosts without an allocator of their own.
uint8_t *clubface_allocate(size_t bytes);

// Gives memory back.
//
// # Safety
// `memory` and `bytes` are those of one call of [`clubface_allocate`].
void clubface_release(uint8_t *memory, size_t bytes);

// Hits `count` shots of a golfer and sums up where they go.
//
// `text` is JSON: `model`, its `parameters`, `inputs` of an impact and `flight`, those of a flight, in their order (null
// for infinite, and for what a shot replaces); the `golfer` with `variables` (names of inputs of the delivery), their
// `mean` and `covariance`, perhaps `mirrored` (variables whose deviations change their sign), `mishit_share` and
// `mishit_scale`; perhaps a `hole` (`length`, `fairway`, `rough`, `green`, and `tables` of `distance` and `strokes` for
// green, fairway, rough and recovery), `seed`, `tolerance`, shares for `percentiles` and `ellipses`.
//
// The text of the result has `shots`, `lost`, `quantities` with `mean`, `spread` and `percentiles`, `ellipses`, and with
// a hole `strokes` and `lies`; the array `landings` the places of the first `landings` shots, ahead and to the right.
// `threads`: 0 for one a core.
//
// # Safety
// `text` ends with a null byte.
ClubfaceResult *clubface_dispersion(const char *text,
                                    uint32_t count,
                                    size_t landings,
                                    size_t threads);

// Strikes a face everywhere.
//
// `text` is JSON: `model`, its `parameters`, `inputs` of an impact and `flight`, those of a flight, in their order (null
// for infinite, and for what the launch replaces); the `outline`, corners of a face that bulges outwards everywhere,
// towards the toe and up it; a `grid` of two numbers of points over the box around it, or `points`, two lists of places.
// Perhaps `tolerance`; `best`, quantities whose greatest values are searched; `share` of the greatest ball speed from
// which a point counts as part of the effective face; and `scatter` of impacts: two standard `deviations` and the point
// that they are `about`, the centre unless given.
//
// The text of the result has `quantities`, the `face_area`, values at the `centre`, and what was asked for: `best` by
// names as `toe`, `high` and `value`, the `effective_area`, and `forgiveness` with the share of swings that `missed` the
// face, and `mean`, `deviation` and `loss` by names. Arrays: places `toe` and `high`, the `values` by quantity, height
// and place towards the toe, beyond the outline as well, and 1 where a point is `inside`. `threads`: 0 for one a core.
//
// # Safety
// `text` ends with a null byte.
ClubfaceResult *clubface_face_map(const char *text,
                                  size_t threads);

// Computes for `rows` heads whether mass in a space can be distributed so.
//
// `text` is JSON: the space by `shape` ("box" or "ellipsoid"), `centre` seen from the face centre and `size` (face to back,
// sole to crown, heel to toe; m); and the `head` that is made lighter evenly by its `free` mass (kg), which is placed anew,
// as its mass properties: mass, `cg_x`, `cg_y`, `cg_z`, `ixx`, `iyy`, `izz`, `ixy`, `ixz`, `iyz`. `values` are columns of
// the same ten numbers, `rows` each. `least` takes the smallest margin of each head: below 0 no body has these numbers.
//
// The text of the result has `margins`, those of the first head, each its `name`, `value` and `reason`, what is wrong where
// it is below 0; and `rounding`, by which a margin may be below 0.
//
// # Safety
// `text` ends with a null byte; the arrays hold as many numbers as stated.
ClubfaceResult *clubface_buildable(const char *text,
                                   const double *values,
                                   size_t rows,
                                   double *least);

// Makes a function a law that pieces name by `law`, in place of one of the same name. `description` has the names of its
// `constants`, `values` of them (SI) to check it with, and its number of state variables, `states`, 0 if left out. The
// text has its modulus of small strains, `shear` (Pa).
//
// # Safety
// The texts end with a null byte; `function` does what [`ClubfaceLaw`] says and is there as long as the program.
ClubfaceResult *clubface_fem_law(const char *name,
                                 ClubfaceLaw function,
                                 const char *description);

// Simulates an impact. `case` describes ball, face, friction and run; see the documentation of the C interface.
//
// The text has the summary (`peak_force`, `contact_time`, `f_prime`, ...), `launch` in the order of the outputs, `stopped`
// (why there is no launch, or null), `nodes` of the ball and of all bodies, `steps`, `step`, `wall` (s). Arrays:
// `contact.time` and other names over the steps, `motion...`, `energy...`, `patch...`, `frame_times`, `frames` (positions
// by frame, node and axis, m), and if asked for `ball.stress`, `ball.strain`, `ball.plastic_strain`, `head.stress`, ...
// A run that `progress` stops keeps what it has.
//
// # Safety
// `case` ends with a null byte; `progress` may be called with `context` during this call.
ClubfaceResult *clubface_fem(const char *case_,
                             ClubfaceProgress progress,
                             void *context);

// Meshes a ball about the origin, its pole of first contact along -x. Arrays: `nodes` by node and axis (m), `elements`
// by element and corner (in binary order), `piece` of each element.
//
// # Safety
// `ball` ends with a null byte.
ClubfaceResult *clubface_fem_ball(const char *ball);

// Weighs a head that deforms: `mass` (kg), `centre` (m), `inertia` (kg m2, rows), in the axes of its nodes; a driver is
// meshed and tuned first. Arrays: `nodes` by node and axis (m), `face` by quadrilateral and corner.
//
// # Safety
// `head` ends with a null byte.
ClubfaceResult *clubface_fem_head(const char *head);

// Computes flights of `rows` launches. `inputs` are the columns of the flight inputs of the description, one after the
// other, `rows` numbers each; `outputs` takes the flight outputs. Rows that cannot be flown are NaN, and named in the
// text. `threads`: 0 for one a core.
//
// # Safety
// The arrays hold as many numbers as stated.
ClubfaceResult *clubface_flights(const double *inputs,
                                 size_t rows,
                                 size_t threads,
                                 double *outputs);

// Computes one flight and all its derivatives: in `jacobian` a row an output, by the inputs.
//
// # Safety
// The arrays hold as many numbers as stated.
ClubfaceResult *clubface_flight_sensitivity(const double *inputs,
                                            double *outputs,
                                            double *jacobian);

// Computes the path of one flight: arrays `time`, `position`, `velocity` and `spin` over its points, world axes. The
// last point is the landing.
//
// # Safety
// `inputs` holds as many numbers as there are flight inputs.
ClubfaceResult *clubface_trajectory(const double *inputs);

// Returns the pressure of the standard atmosphere at an altitude above the sea, Pa; the altitude in m.
double clubface_pressure_at_altitude(double altitude);

// Returns the density of moist air, kg/m3: temperature in K, pressure in Pa, humidity relative to saturation, 0 to 1.
double clubface_air_density(double temperature,
                            double pressure,
                            double humidity);

// Names `rows` shots by their shape, as the text of the result: a list of names such as "pull hook", empty for a shot that
// does not fly. `azimuth` (rad) and `curve` and `carry` (m) are columns of launches and flights; `hand` is 1 for a
// right-handed player, -1 for a left-handed one. The limits between the names stand in the description.
//
// # Safety
// The arrays hold `rows` numbers each.
ClubfaceResult *clubface_shot_shapes(const double *azimuth,
                                     const double *curve,
                                     const double *carry,
                                     size_t rows,
                                     double hand);

// Returns how many columns there are, of `CLUBFACE_COLUMNS_INPUTS` and so on.
size_t clubface_count(uint32_t columns);

// Returns the place of a column, counted from 0, by its name, such as "speed"; -1 if there is none of this name.
//
// # Safety
// `name` is null or ends with a null byte.
ptrdiff_t clubface_column(uint32_t columns,
                          const char *name);

// Writes the default parameters of a model to `parameters`, unless it is null. Returns how many there are; -1 for a model
// that is unknown.
//
// # Safety
// `model` is null or ends with a null byte; `parameters` is null or has room for as many numbers as this returns.
ptrdiff_t clubface_default_parameters(const char *model,
                                      double *parameters);

// Writes the default flight inputs; what has none, the launch, is NaN.
//
// # Safety
// `inputs` has room for as many numbers as there are flight inputs.
void clubface_default_flight(double *inputs);

// Returns why the computation failed, as `{"input", "message"}` and perhaps `"value"`, or null if it did not.
//
// # Safety
// `result` comes from this library and has not been freed.
const char *clubface_error(const ClubfaceResult *result);

// Returns the text of the result; of rows, the list of those that could not be computed: `{"row", "input", "message"}`.
//
// # Safety
// `result` comes from this library and has not been freed.
const char *clubface_text(const ClubfaceResult *result);

// Returns the number of arrays of the result.
//
// # Safety
// `result` comes from this library and has not been freed.
size_t clubface_array_count(const ClubfaceResult *result);

// Returns the name of an array, counted from 0; null if there are not so many.
//
// # Safety
// `result` comes from this library and has not been freed.
const char *clubface_array_name(const ClubfaceResult *result, size_t array);

// Returns the numbers of an array, and writes how many there are and of which kind; null if there is no such array.
//
// # Safety
// `result` comes from this library and has not been freed; `length` and `kind` may be written, or are null.
const void *clubface_array(const ClubfaceResult *result,
                           size_t array,
                           size_t *length,
                           ClubfaceKind *kind);

// Returns the size of an array along an axis, counted from 0; 0 if it has no such axis.
//
// # Safety
// `result` comes from this library and has not been freed.
size_t clubface_array_size(const ClubfaceResult *result, size_t array, size_t axis);

// Ends a result; null is allowed.
//
// # Safety
// `result` comes from this library and has not been freed.
void clubface_free(ClubfaceResult *result);

// Computes launches of `rows` shots by a model.
//
// `inputs` are the columns of the description, one after the other, `rows` numbers each; `outputs` takes as many columns
// as the description has outputs. `parameters` are the model's, alike for all shots. `tolerance` is relative, of a step
// of a contact; 0 is the fast setting. `threads`: 0 for one a core. Rows that cannot be computed are NaN, and named in
// the text.
//
// # Safety
// The arrays hold as many numbers as stated; `model` ends with a null byte.
ClubfaceResult *clubface_launches(const char *model,
                                  const double *inputs,
                                  const double *parameters,
                                  size_t rows,
                                  double tolerance,
                                  size_t threads,
                                  double *outputs);

// Computes one launch and all its derivatives: in `jacobian` a row an output, by the inputs and then the parameters. It
// is NaN by an input that is not differentiable, and by the group "attachment" where all of it is zero. The rest as for
// [`clubface_launches`].
//
// # Safety
// The arrays hold as many numbers as stated; `model` ends with a null byte.
ClubfaceResult *clubface_sensitivity(const char *model,
                                     const double *inputs,
                                     const double *parameters,
                                     double tolerance,
                                     double *outputs,
                                     double *jacobian);

// Computes chosen outputs of `rows` shots and their derivatives by chosen variables.
//
// `outputs` are `output_count` indices into the outputs, `variables` are `variable_count` indices into the inputs
// followed by the parameters. `values` takes columns: for each output, its values and then its derivatives by each
// variable. The rest as for [`clubface_launches`].
//
// # Safety
// The arrays hold as many numbers as stated; `model` ends with a null byte.
ClubfaceResult *clubface_sensitivities(const char *model,
                                       const double *inputs,
                                       const double *parameters,
                                       size_t rows,
                                       const size_t *outputs,
                                       size_t output_count,
                                       const size_t *variables,
                                       size_t variable_count,
                                       double tolerance,
                                       size_t threads,
                                       double *values);

// Computes the history of one shot by a contact model: arrays over the steps (`time`, `normal_force`, `force_y`,
// `penetration`, `ball_spin`, ...), world axes, and its outputs as `launch`. The rest as for [`clubface_launches`].
//
// # Safety
// The arrays hold as many numbers as stated; `model` ends with a null byte.
ClubfaceResult *clubface_history(const char *model,
                                 const double *inputs,
                                 const double *parameters,
                                 double tolerance);

// Begins a contact of a model where head and ball are now, which should be at first touch.
//
// `inputs` are a shot's, of which those of the delivery have no part; `parameters` are the model's. `contact` takes the
// contact, null after an error. The text of the result lists the names of the internal states of the law, and the array
// `internal` their values at first touch. States that belong to a face are in its axes: x along the normal at its centre, y
// up, z towards the toe.
//
// # Safety
// The arrays hold as many numbers as stated; `model` ends with a null byte; `contact` may be written.
ClubfaceResult *clubface_contact_begin(const char *model,
                                       const double *inputs,
                                       const double *parameters,
                                       const double *head,
                                       const double *ball,
                                       ClubfaceContact **contact);

// Computes what acts between head and ball: `wrench` takes [`CLUBFACE_WRENCH`] numbers, `rates` those of the internal
// states. A function of its arguments alone, which are not checked.
//
// # Safety
// `contact` comes from [`clubface_contact_begin`] and has not been ended; the arrays hold as many numbers as stated.
void clubface_contact_evaluate(const ClubfaceContact *contact,
                               const double *head,
                               const double *ball,
                               const double *internal,
                               double *wrench,
                               double *rates);

// Computes the derivatives of what acts: `values` takes a row for each of the [`CLUBFACE_WRENCH`] numbers and then for each
// rate of an internal state, with its value first and then its derivatives by the [`CLUBFACE_MOTION`] numbers of motion and
// by the internal states.
//
// # Safety
// As of [`clubface_contact_evaluate`].
void clubface_contact_jacobian(const ClubfaceContact *contact,
                               const double *head,
                               const double *ball,
                               const double *internal,
                               double *values);

// Ends a step of the caller's integrator: brings what a law remembers (rings) up to date, in `internal`. The other states
// are the caller's to integrate. To be called after every step that is accepted, with the motion at its end.
//
// # Safety
// As of [`clubface_contact_evaluate`]; `internal` may be written.
void clubface_contact_commit(const ClubfaceContact *contact,
                             const double *head,
                             const double *ball,
                             double *internal);

// Ends a contact; null is allowed.
//
// # Safety
// `contact` comes from [`clubface_contact_begin`] and has not been ended.
void clubface_contact_end(ClubfaceContact *contact);

// Places a ball that a head will strike, for programs that exchange forces at steps of their own.
//
// `gives_way`: 1 for a head that within a step gives way to the ball by the inertia of the inputs, as a body does; 0 for one
// that moves as prescribed. `struck` takes the ball, null after an error. The rest as for [`clubface_contact_begin`].
//
// # Safety
// The arrays hold as many numbers as stated; `model` ends with a null byte; `struck` may be written.
ClubfaceResult *clubface_ball_place(const char *model,
                                    const double *inputs,
                                    const double *parameters,
                                    const double *ball,
                                    bool gives_way,
                                    ClubfaceStruckBall **struck);

// Moves a ball on by `duration` seconds while the head moves on from where it is now. `loads` takes [`CLUBFACE_STEP`]
// numbers, to be applied to the head over the step, `ball` takes where the ball is then and how it moves.
//
// # Safety
// `struck` comes from [`clubface_ball_place`] and has not been ended; the arrays hold as many numbers as stated.
ClubfaceResult *clubface_ball_advance(ClubfaceStruckBall *struck,
                                      const double *head,
                                      double duration,
                                      double *loads,
                                      double *ball);

// Returns 0 while the head has not reached the ball, 1 while they touch, 2 once the ball has left the face.
//
// # Safety
// `struck` comes from [`clubface_ball_place`] and has not been ended.
int32_t clubface_ball_phase(const ClubfaceStruckBall *struck);

// Writes the outputs of the impact once the ball has left the face, and says whether it has.
//
// # Safety
// `struck` comes from [`clubface_ball_place`] and has not been ended; `outputs` has room for those of the description.
bool clubface_ball_launch(const ClubfaceStruckBall *struck,
                          double *outputs);

// Ends a struck ball; null is allowed.
//
// # Safety
// `struck` comes from [`clubface_ball_place`] and has not been ended.
void clubface_ball_end(ClubfaceStruckBall *struck);

#ifdef __cplusplus
}  // extern "C"
#endif  // __cplusplus

#endif  /* CLUBFACE_H */
