package arcomat.pipeline.world;

import arcomat.pipeline.beside.BesideText;
import arcomat.pipeline.beside.TextsAround;
import arcomat.pipeline.check.MainComponent;
import arcomat.pipeline.recheck.OpenModels;
import arcomat.source.Diagnostic;
import arcomat.source.SourceFile;
import arcomat.symbols.bodies.ComponentSymbol;
import arcomat.world.Kind;
import arcomat.world.Kind.Program.Form;
import arcomat.world.World;
import arcomat.world.WorldParameter;
import arcomat.world.WorldParser;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Objects;
import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * A world, while somebody writes it. Of its programs only the names are looked at: a jar is made
 * when the world runs.
 *
 * @param place of the file, absolute
 */
public record WorldLines(SourceFile text, Path place, TextsAround around) implements BesideText {
    private static final Pattern USE = Pattern.compile("\\$(\\w+)");

    @Override
    public List<Diagnostic> findings() {
        WorldParser.Parsed parsed = WorldParser.parse(text);
        List<Diagnostic> findings = new ArrayList<>(parsed.findings());
        parsed.world().ifPresent(world -> addPrograms(world, findings));
        return findings;
    }

    private void addPrograms(World world, List<Diagnostic> findings) {
        world.robots().stream()
                .map(robot -> robot.kind().program())
                .distinct()
                .forEach(
                        program ->
                                obstacle(program)
                                        .map(why -> program.error(WorldPrograms.NO_PROGRAM, why))
                                        .ifPresent(findings::add));
    }

    private Optional<String> obstacle(Kind.Program program) {
        if (program.form() == Form.JAR) {
            return Files.isRegularFile(beside(program.name()))
                    ? Optional.empty()
                    : Optional.of("there is no jar '" + program.name() + "'");
        }
        return around.models(beside(program.folder()))
                .flatMap(models -> MainComponent.obstacle(program.name(), models.workspace()));
    }

    private Path beside(String written) {
        return Objects.requireNonNull(place.getParent()).resolve(written).normalize();
    }

    @Override
    public List<Link> links() {
        List<Link> links = new ArrayList<>();
        WorldParser.parse(text).programs().forEach(program -> addProgram(program, links));
        addParameters(links);
        return links;
    }

    private void addProgram(Kind.Program program, List<Link> links) {
        if (program.form() == Form.JAR) {
            links.add(new Link(program.named().place(), beside(program.name()), Optional.empty()));
            return;
        }
        around.models(beside(program.folder()))
                .ifPresent(models -> addComponent(program, models, links));
    }

    private static void addComponent(Kind.Program program, OpenModels models, List<Link> links) {
        MainComponent.symbols(program.name(), models.workspace()).stream()
                .map(ComponentSymbol::nameSpan)
                .map(
                        name ->
                                new Link(
                                        program.named().place(),
                                        models.root().resolve(name.file().path()),
                                        Optional.of(name)))
                .forEach(links::add);
    }

    private void addParameters(List<Link> links) {
        List<WorldParameter> parameters = WorldParser.parameters(text);
        Matcher uses = USE.matcher(text.text());
        while (uses.find()) {
            for (WorldParameter parameter : parameters) {
                if (parameter.name().equals(uses.group(1))) {
                    links.add(
                            new Link(
                                    text.span(uses.start(), uses.end()),
                                    place,
                                    Optional.of(parameter.place())));
                }
            }
        }
    }

    @Override
    public List<Choice> choices(int offset) {
        Path folder = Objects.requireNonNull(place.getParent());
        return new WorldChoices(text, new ProgramsBeside(folder, around)).at(offset);
    }
}
