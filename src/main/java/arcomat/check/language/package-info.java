/**
 * What the tool's own languages for behaviours find wrong with texts. Each language says it by
 * itself; here it is asked for, so that profiles and suppressions are as for all laws.
 */
package arcomat.check.language;
