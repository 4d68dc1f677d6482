/**
 * Pictures of models where the tool's own layout cannot run: what is to be placed goes to the
 * engine of the page as JSON, and where that has put it comes back.
 */
package arcomat.live.picture;
