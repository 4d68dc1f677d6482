/**
 * What lies in a folder of models, and what the names in them mean: {@code Folder} knows what is
 * there, {@code Lacks} what cannot be converted.
 */
package montiarc7.source;
