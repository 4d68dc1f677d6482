/**
 * The documentation as a site. Pages are those of the repository, with their links turned round;
 * what a link or a heading promises is there, or there is no site. Models on them open on the live
 * page. The same texts give the same bytes.
 */
@NullMarked
package arcomat.site;

import org.jspecify.annotations.NullMarked;
