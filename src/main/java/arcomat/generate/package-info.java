/**
 * Source text out of models: a target is a folder of templates with a description of its language;
 * models become flat view records, templates give files their shape. Pure: returns files or
 * findings. Knows neither the text of models nor how files are written, compiled or run.
 */
package arcomat.generate;
