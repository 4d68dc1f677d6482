/**
 * The ground: text files, places in them, findings about them and edits that mend them. Every room
 * may import this one; it knows no other.
 */
package arcomat.source;
