/**
 * Finds, reads and writes files and folders; what is written is written as a whole or not at all.
 * Brings files into canonical form. Knows models only as text with an ending.
 */
package arcomat.pipeline.file;
