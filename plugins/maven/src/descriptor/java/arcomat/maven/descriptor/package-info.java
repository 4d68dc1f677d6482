/** Tells Maven of the goals of the plugin; runs while it is built, and is no part of it. */
package arcomat.maven.descriptor;
