/**
 * The door for what others add: a guest is a jar, or a folder of classes, with a class that
 * implements {@link arcomat.guest.Guest} and is named as a service. What a guest sees besides are
 * the rooms that this one may use; together they are the jar {@code arcomat-api}.
 */
package arcomat.guest;
