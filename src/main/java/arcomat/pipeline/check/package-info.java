/**
 * From paths to models that are checked and lowered: the model roots, the library, the main
 * component, promises by name. Knows nothing of what the models are wanted for.
 */
package arcomat.pipeline.check;
