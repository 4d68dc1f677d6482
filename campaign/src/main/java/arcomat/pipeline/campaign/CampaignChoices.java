package arcomat.pipeline.campaign;

import arcomat.campaign.Campaign;
import arcomat.campaign.CampaignParser;
import arcomat.pipeline.beside.BesideText;
import arcomat.pipeline.beside.BesideText.Choice;
import arcomat.pipeline.beside.TextsAround;
import arcomat.pipeline.campaign.measure.Vocabulary;
import arcomat.source.SourceFile;
import arcomat.world.WorldParser;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Objects;
import java.util.Optional;
import java.util.regex.MatchResult;
import java.util.regex.Pattern;
import java.util.stream.Stream;

/**
 * What may stand at a place of a campaign.
 *
 * @param place of the file, absolute
 */
record CampaignChoices(SourceFile text, Path place, TextsAround around) {
    private static final Pattern WORLD = Pattern.compile("(?m)^\\s*world\\s+(\\S+)");
    private static final Pattern VARIED = Pattern.compile("(?m)^\\s*vary\\s+(\\S+)");

    List<Choice> at(int offset) {
        SourceFile before = BesideText.before(text, offset);
        List<String> line = BesideText.lastLine(before);
        List<Choice> words = Choice.words(CampaignParser.choicesAfter(before));
        return words.isEmpty() && !line.isEmpty() ? names(line, before) : words;
    }

    /** Behind some words, where the language has none of its own. */
    private List<Choice> names(List<String> line, SourceFile before) {
        int size = line.size();
        return switch (line.get(0)) {
            case "world" -> size == 1 ? worlds() : List.of();
            case "vary" -> size == 1 ? parameters() : List.of();
            case "compare" -> size == 1 ? varied() : List.of();
            case "measure", "event" -> size > 2 ? readings(before) : List.of();
            default -> List.of();
        };
    }

    /** Beside the campaign. */
    private List<Choice> worlds() {
        try (Stream<Path> files = Files.list(Objects.requireNonNull(place.getParent()))) {
            return files.map(file -> file.getFileName().toString())
                    .filter(name -> name.endsWith(".world"))
                    .sorted()
                    .map(name -> new Choice(name, "world"))
                    .toList();
        } catch (IOException noFolder) {
            return List.of();
        }
    }

    /** Those of the world of which the campaign does not speak yet. */
    private List<Choice> parameters() {
        List<String> known = varied().stream().map(Choice::word).toList();
        return world().map(WorldParser::parameters).orElse(List.of()).stream()
                .filter(each -> !known.contains(each.name()))
                .map(each -> new Choice(each.name(), "parameter, usually " + each.usual()))
                .toList();
    }

    private Optional<SourceFile> world() {
        return WORLD.matcher(text.text())
                .results()
                .findFirst()
                .map(found -> found.group(1))
                .flatMap(
                        file ->
                                around.text(
                                        Objects.requireNonNull(place.getParent())
                                                .resolve(file)
                                                .normalize()));
    }

    private List<Choice> varied() {
        return VARIED.matcher(text.text())
                .results()
                .map((MatchResult found) -> new Choice(found.group(1), "parameter that varies"))
                .distinct()
                .toList();
    }

    /**
     * What can be read of robots and drinkers, as far as the campaign is right without the line.
     */
    private List<Choice> readings(SourceFile before) {
        Optional<Campaign> campaign = CampaignParser.parse(without(before)).campaign();
        return campaign.isEmpty()
                ? List.of()
                : world()
                        .map(world -> Vocabulary.of(campaign.get(), world).readings())
                        .orElse(List.of())
                        .stream()
                        .map(name -> new Choice(name, "what can be read in the world"))
                        .toList();
    }

    /** The text without the line that is being written. */
    private SourceFile without(SourceFile before) {
        int start = before.lineStart(before.lineCount());
        int end = text.text().indexOf('\n', before.text().length());
        String rest = end < 0 ? "" : text.text().substring(end);
        return new SourceFile(text.path(), text.text().substring(0, start) + rest);
    }
}
