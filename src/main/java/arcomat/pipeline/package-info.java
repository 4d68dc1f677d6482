/**
 * The corridor: the only room that knows the order of the steps, from paths to findings, runs and
 * generated files. Reads and writes files, compiles and loads; knows nothing of arguments,
 * terminals and exit statuses. A {@link arcomat.pipeline.Task} is one record in the folder of its
 * subject, and a {@link arcomat.pipeline.Session} runs it; here is what all of them share, which
 * knows none of them.
 */
package arcomat.pipeline;
