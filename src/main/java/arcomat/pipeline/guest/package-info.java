/**
 * How guests arrive: their jars are opened, they are asked what they bring, and what cannot stand
 * beside something else is refused before any model is read.
 */
package arcomat.pipeline.guest;
