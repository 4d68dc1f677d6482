/**
 * What a search has explored, in the files of a folder: for one question, or for all that models
 * promise, about these models, by this version of the tool. It is gone on with after whatever has
 * ended the search.
 */
package arcomat.pipeline.explored;
