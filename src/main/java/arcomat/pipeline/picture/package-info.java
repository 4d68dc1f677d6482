/**
 * One picture as a file: its format, its links into the models. Knows nothing of which pictures are
 * wanted.
 */
package arcomat.pipeline.picture;
