package arcomat;

import static org.assertj.core.api.Assertions.assertThat;

import com.tngtech.archunit.core.domain.JavaClass;

import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.regex.MatchResult;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/**
 * The architecture page shows what the classes import, and names what there is. {@code
 * -Dtranscripts.update=true} draws it anew.
 */
class ArchitecturePageTest {
    /** Once for all cases: it takes seconds. */
    @BeforeAll
    static void readClasses() {
        assertThat(House.rooms()).isNotEmpty();
    }

    private static final Path PAGE = Path.of("docs/architecture.md");
    private static final List<String> TESTED =
            Stream.concat(House.WINGS.stream(), Stream.of("docs")).toList();
    private static final boolean UPDATE = Boolean.getBoolean("transcripts.update");

    @Tag("slow")
    @Test
    void theDrawingIsCurrent() throws IOException {
        String page = Files.readString(PAGE);
        Matcher block = Pattern.compile("(?s)```rooms\n(.*?)```").matcher(page);
        assertThat(block.find()).isTrue();
        String drawing = drawing();
        if (UPDATE) {
            Files.writeString(
                    PAGE,
                    page.substring(0, block.start(1)) + drawing + page.substring(block.end(1)));
        }
        assertThat(block.group(1)).isEqualTo(drawing);
    }

    private static String drawing() {
        Map<String, Set<String>> imports = imports();
        Map<String, Integer> floors = new TreeMap<>();
        imports.keySet().forEach(room -> floor(room, imports, floors));
        int top = floors.values().stream().max(Integer::compare).orElseThrow();
        StringBuilder text = new StringBuilder();
        for (int floor = top; floor >= 0; floor--) {
            List<String> rooms = new ArrayList<>();
            for (String room : imports.keySet()) {
                if (floors.get(room) == floor) {
                    rooms.add(room);
                }
            }
            text.append("floor %d   %s%n".formatted(floor, String.join("   ", rooms)));
        }
        text.append(
                "\n%-10s  stands on the ground (%s) and on%n".formatted("", names(House.GROUND)));
        imports.forEach(
                (room, used) -> {
                    Set<String> others = new TreeSet<>(used);
                    others.removeAll(House.GROUND);
                    if (!others.isEmpty()) {
                        text.append("%-10s  %s%n".formatted(room, names(others)));
                    }
                });
        return text.toString();
    }

    private static String names(Set<String> rooms) {
        return String.join(" ", new TreeSet<>(rooms));
    }

    private static int floor(
            String room, Map<String, Set<String>> imports, Map<String, Integer> floors) {
        Integer known = floors.get(room);
        if (known != null) {
            return known;
        }
        int floor = 0;
        for (String below : imports.get(room)) {
            floor = Math.max(floor, 1 + floor(below, imports, floors));
        }
        floors.put(room, floor);
        return floor;
    }

    /** Of each room, the others that its classes import; generated parsers are syntax. */
    private static Map<String, Set<String>> imports() {
        Map<String, Set<String>> imports = new TreeMap<>();
        for (JavaClass each : House.CLASSES) {
            String room = House.room(each);
            if (House.APART.contains(room)) {
                continue;
            }
            Set<String> used = imports.computeIfAbsent(room, name -> new TreeSet<>());
            each.getDirectDependenciesFromSelf().stream()
                    .map(dependency -> dependency.getTargetClass().getBaseComponentType())
                    .filter(target -> target.getPackageName().startsWith("arcomat."))
                    .map(House::room)
                    .filter(other -> !other.equals(room) && !House.APART.contains(other))
                    .forEach(used::add);
        }
        return imports;
    }

    /** Names in code type that look like those of packages and classes are such names. */
    @Test
    void whatThePageNamesExists() throws IOException {
        Set<String> known =
                House.CLASSES.stream()
                        .filter(each -> each.getEnclosingClass().isEmpty())
                        .flatMap(each -> endings(each.getName()).stream())
                        .collect(Collectors.toSet());
        House.CLASSES.forEach(each -> known.addAll(endings(each.getPackageName())));
        for (String project : TESTED) {
            try (var files = Files.walk(Path.of(project, "src/test/java/arcomat"))) {
                files.map(file -> file.getFileName().toString())
                        .filter(file -> file.endsWith(".java"))
                        .forEach(file -> known.add(file.replace(".java", "")));
            }
        }
        String prose = Files.readString(PAGE).replaceAll("(?s)```.*?```", "");
        List<String> unknown =
                Pattern.compile("`([a-z]+(?:\\.[a-z]+)*(?:\\.[A-Z]\\w*)?|[A-Z]\\w+)(?:\\.\\w+)?`")
                        .matcher(prose)
                        .results()
                        .map(MatchResult::group)
                        .map(name -> name.replace("`", ""))
                        .filter(name -> name.contains(".") || Character.isUpperCase(name.charAt(0)))
                        .filter(name -> !known.contains(name))
                        .filter(name -> !known.contains(name.replaceAll("\\.\\w+$", "")))
                        .toList();
        assertThat(unknown).isEmpty();
    }

    /** {@code arcomat.check.Checks} may be named {@code check.Checks} or {@code Checks}, too. */
    private static Set<String> endings(String name) {
        Set<String> endings = new TreeSet<>();
        for (String rest = name; ; rest = rest.substring(rest.indexOf('.') + 1)) {
            endings.add(rest);
            if (!rest.contains(".")) {
                return endings;
            }
        }
    }

    @Test
    void everyRoomHasAParagraph() throws IOException {
        String page = Files.readString(PAGE);
        assertThat(imports().keySet())
                .allSatisfy(room -> assertThat(page).contains("* **" + room + "**: "));
    }
}
