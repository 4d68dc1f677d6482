/**
 * The corridor: the only room that knows the order of the steps, from paths to findings, runs and
 * generated files. Reads and writes files, compiles and loads; knows nothing of arguments,
 * terminals and exit statuses.
 */
package arcomat.pipeline;
