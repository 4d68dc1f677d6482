/**
 * What a law is, what it is told and what it may say: code, severity and profile, the element that
 * it is about, findings with fixes, and findings that are meant.
 */
package arcomat.check.law;
