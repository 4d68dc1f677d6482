/** JSON for the page. */
package arcomat.live.json;
