package arcomat.world;

import arcomat.source.Span;

/**
 * Something that a world leaves to whoever runs it: {@code parameter NAME VALUE}. Wherever a word
 * may stand, {@code $NAME} stands for its value.
 *
 * @param usual its value where nobody gives another one
 * @param place of its name
 */
public record WorldParameter(String name, String usual, Span place) {}
