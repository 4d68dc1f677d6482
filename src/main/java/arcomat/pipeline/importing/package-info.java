/**
 * Models of other languages: a guest reads them, and what it makes of them is judged and written.
 */
package arcomat.pipeline.importing;
