package arcomat.editor.desk;

import arcomat.source.SourceFile;

import java.util.List;
import java.util.function.Predicate;

/**
 * What lies beside models and may name what they define.
 *
 * @param texts with absolute paths
 * @param isAmbiguous whether models of another root have a component of a qualified name, so that
 *     nobody knows which one is meant
 */
public record OtherTexts(List<SourceFile> texts, Predicate<String> isAmbiguous) {}
