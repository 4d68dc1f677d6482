/**
 * Targets: how models become files. A target is a folder of templates and a description of its
 * language; all knowledge about Java, leJOS or C is there. Knows neither text nor checks.
 *
 * <p>From below: {@code language} spells things, {@code text} writes conditions and expressions,
 * {@code plan} decides what the code does in which order, {@code views} and {@code monitor} make
 * the records of {@code view}, and here the templates of a target are filled in with them.
 */
package arcomat.generate;
