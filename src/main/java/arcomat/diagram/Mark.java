package arcomat.diagram;

import arcomat.source.Span;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/**
 * What an element of a picture stands for.
 *
 * @param kind what it is, such as {@code state}; also the class that styles it
 * @param name tells it from others of its kind in one picture: a path, or a number
 * @param styles further classes
 * @param place where the model declares it
 * @param tooltip shown on request; empty for none
 */
public record Mark(
        String kind, String name, List<String> styles, Optional<Span> place, String tooltip) {
    public Mark {
        styles = List.copyOf(styles);
    }

    static Mark of(String kind, String name, Span place) {
        return new Mark(kind, name, List.of(), Optional.of(place), "");
    }

    static Mark unplaced(String kind, String name) {
        return new Mark(kind, name, List.of(), Optional.empty(), "");
    }

    Mark styled(String style) {
        List<String> more = new ArrayList<>(styles);
        more.add(style);
        return new Mark(kind, name, more, place, tooltip);
    }

    Mark telling(String text) {
        String both = tooltip.isEmpty() ? text : tooltip + "\n" + text;
        return new Mark(kind, name, styles, place, both);
    }
}
