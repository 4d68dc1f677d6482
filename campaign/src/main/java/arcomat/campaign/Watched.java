package arcomat.campaign;

import arcomat.source.Span;
import arcomat.world.Word;
import arcomat.world.Words;
import arcomat.world.Words.Unreadable;

/**
 * A requirement of the models that the programs of robots watch themselves for: the event is that
 * one of them has seen it violated.
 *
 * @param name of the column
 * @param requirement with the part that is watched, as {@code generate --monitor} names them
 * @param place of the requirement in the campaign
 */
public record Watched(String name, String requirement, Span place) {
    /** {@code watch NAME REQUIREMENT}, behind its first word. */
    static Watched of(Words words) throws Unreadable {
        Word name = Measure.columnName(words);
        Span requirement = words.rest("a requirement of the models, such as p.Caution");
        return new Watched(name.text(), requirement.text(), requirement);
    }

    Column column() {
        return new Column(name, true, requirement + " was violated");
    }
}
