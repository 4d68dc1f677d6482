/** Brings files into canonical form. Knows nothing of what they mean. */
package arcomat.pipeline.format;
