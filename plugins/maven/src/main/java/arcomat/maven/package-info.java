/**
 * The Maven plugin: models are checked, tested, verified and compiled as a part of a Maven build.
 * It calls the tool's command line inside of Maven's process, as it is meant for other programs: it
 * ends no process but its own work.
 */
package arcomat.maven;
