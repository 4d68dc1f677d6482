/**
 * What templates see: flat records of ready-made text. A template needs no other knowledge of the
 * model than these, whatever its language.
 */
package arcomat.generate.view;
