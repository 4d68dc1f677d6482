/** The views of classes that watch a component while it runs, also inside of its own program. */
package arcomat.generate.monitor;
