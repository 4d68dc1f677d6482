/**
 * The Gradle plugin: models as a normal part of a build. It knows Gradle and the tool's command
 * line, and nothing else of the tool, whose version a build chooses: commands run in worker
 * processes of the build.
 */
package arcomat.gradle;
