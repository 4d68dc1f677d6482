/**
 * Context conditions: whether what was written is well-formed. One law is one class, one code, one
 * data file and one page of explanation; {@link arcomat.check.Checks} lists them. A check looks at
 * trees and symbols and returns findings; it changes nothing, and it knows neither the parser nor
 * what a model means when it runs.
 */
package arcomat.check;
