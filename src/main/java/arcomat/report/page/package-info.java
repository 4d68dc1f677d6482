/**
 * A page for browsers that stands alone: what was asked, what came of it, and runs to go through
 * step by step. Knows runs only as columns of texts, and pictures only as SVG; the looks and the
 * behaviour of the page are files of their own, under {@code resources/report}.
 */
package arcomat.report.page;
