/** The guests of a session, as the tool knows them; guests themselves do not see this. */
package arcomat.guest.host;
