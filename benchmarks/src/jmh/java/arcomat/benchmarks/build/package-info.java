/**
 * What the Gradle plugin adds to a build that has nothing to do: whole builds, in a warm daemon.
 */
package arcomat.benchmarks.build;
