/** Conditions and expressions of a model in the language of a target, as one file names things. */
package arcomat.generate.text;
