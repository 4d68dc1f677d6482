/** The language server, as a process of its own, with a thousand models in its workspace. */
package arcomat.benchmarks.editor;
