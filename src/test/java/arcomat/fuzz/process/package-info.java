/**
 * The installed tool as a process, with damaged input: models, jars, worlds, scripts, files of
 * state, certificates, baselines, folders of templates. Whatever is wrong with them, the tool says
 * so in words, soon, with the right exit status, and writes nothing half or elsewhere.
 */
package arcomat.fuzz.process;
