package arcomat.check.guest;

import arcomat.check.law.Law;

import java.util.List;
import java.util.Optional;
import java.util.function.Function;

/**
 * The laws of one guest.
 *
 * @param guest its name
 * @param identity tells it from every other guest, and from itself with other content
 * @param pages what it has to say about a code, in Markdown
 */
public record GuestLaws(
        String guest, String identity, List<Law> laws, Function<String, Optional<String>> pages) {
    public GuestLaws {
        laws = List.copyOf(laws);
    }
}
