package arcomat.brick.need;

import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;

/** Knows what leJOS' own classes use of each other, by the resource {@code links.txt}. */
final class LibraryLinks {
    private static final String RESOURCE = "/brick/links.txt";

    private final List<String> names = new ArrayList<>();
    private final List<String> signatures = new ArrayList<>();

    /** The lines about each class, the first of which has what is above it. */
    private final Map<String, List<String>> lines = new HashMap<>();

    private LibraryLinks() {}

    static LibraryLinks read() {
        try (InputStream in = LibraryLinks.class.getResourceAsStream(RESOURCE)) {
            LibraryLinks links = new LibraryLinks();
            String text = new String(in.readAllBytes(), StandardCharsets.UTF_8);
            List<String> current = new ArrayList<>();
            for (String line : text.split("\n")) {
                String rest = line.substring(line.indexOf(' ') + 1);
                if (line.startsWith("name ")) {
                    links.names.add(rest);
                } else if (line.startsWith("signature ")) {
                    links.signatures.add(rest);
                } else if (line.startsWith("class ")) {
                    current = new ArrayList<>();
                    links.lines.put(links.name(rest.split(" ")[0]), current);
                    current.add(line);
                } else if (!line.startsWith("#")) {
                    current.add(line);
                }
            }
            return links;
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    private String name(String number) {
        return names.get(Integer.parseInt(number));
    }

    private String signature(String number) {
        return signatures.get(Integer.parseInt(number));
    }

    /** A class of leJOS. */
    Optional<LinkedType> type(String name) {
        return Optional.ofNullable(lines.get(name)).map(this::read);
    }

    private LinkedType read(List<String> about) {
        String[] head = about.get(0).split(" ");
        List<String> interfaces = new ArrayList<>();
        for (int i = 3; i < head.length; i++) {
            interfaces.add(name(head[i]));
        }
        Optional<String> parent =
                head[2].equals("-") ? Optional.empty() : Optional.of(name(head[2]));
        Set<String> caught = new LinkedHashSet<>();
        Map<String, LinkedType.Body> methods = new LinkedHashMap<>();
        for (String line : about.subList(1, about.size())) {
            String[] words = line.split(" ");
            if (words[0].equals("catch")) {
                words(words).forEach(each -> caught.add(name(each)));
            } else {
                List<LinkedType.Use> uses = words(words).stream().map(this::use).toList();
                boolean isStatic = words[0].charAt(0) == 's';
                methods.put(signature(words[0].substring(1)), new LinkedType.Body(isStatic, uses));
            }
        }
        return new LinkedType(parent, interfaces, methods, caught, Set.of());
    }

    private static List<String> words(String[] line) {
        return List.of(line).subList(1, line.length);
    }

    private LinkedType.Use use(String word) {
        String[] numbers = word.substring(1).split("\\.");
        String signature = numbers.length > 1 ? signature(numbers[1]) : "";
        return new LinkedType.Use(kind(word.charAt(0)), name(numbers[0]), signature);
    }

    private static LinkedType.Kind kind(char letter) {
        return switch (letter) {
            case 'n' -> LinkedType.Kind.OBJECT;
            case 'u' -> LinkedType.Kind.CLASS;
            case 'd' -> LinkedType.Kind.DIRECT;
            case 'v' -> LinkedType.Kind.VIRTUAL;
            case 'i' -> LinkedType.Kind.INTERFACE;
            default -> throw new IllegalStateException("what is " + letter + "?");
        };
    }
}
