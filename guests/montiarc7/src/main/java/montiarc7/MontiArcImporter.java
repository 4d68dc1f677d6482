package montiarc7;

import arcomat.guest.Importer;
import arcomat.guest.Transcription;
import arcomat.source.SourceFile;

import montiarc7.grammar.MontiArc7Parser.UnitContext;
import montiarc7.source.Folder;
import montiarc7.source.Lack;
import montiarc7.source.Lacks;
import montiarc7.source.TypeNames;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/** Reads a folder of MontiArc 7: components and class diagrams. */
final class MontiArcImporter implements Importer {
    /** A component that was read. */
    private record Component(Original original, MontiArcText text, Lacks lacks) {
        MapSide side(Folder folder) {
            return new MapSide(original.path(), text.unit(), folder, lacks.unheard());
        }
    }

    @Override
    public String kind() {
        return "montiarc7";
    }

    @Override
    public List<String> endings() {
        return List.of(".arc", ".cd", ".map");
    }

    @Override
    public List<String> codes() {
        return Arrays.stream(Lack.values()).map(Lack::code).toList();
    }

    @Override
    public void read(List<Original> originals, Transcription transcription) {
        Folder folder = new Folder();
        Map<String, SourceFile> written = new LinkedHashMap<>();
        List<Component> components = new ArrayList<>();
        for (Original each : originals) {
            if (each.path().endsWith(".cd")) {
                String name = folder.addDiagram(each.file().text()).orElse("");
                String path = name.isEmpty() ? each.path() : name.replace('.', '/') + ".cd";
                write(each.file(), path, each.file().text(), written, transcription);
            } else if (each.path().endsWith(".arc")) {
                Lacks lacks = new Lacks(each.file(), transcription);
                MontiArcText text = MontiArcText.of(each.file(), lacks);
                if (!lacks.tell()) {
                    components.add(new Component(each, text, lacks));
                    folder.addComponent(TypeNames.packageOf(text.unit()), text.unit().component());
                }
            }
        }
        components.forEach(each -> convert(each, folder, written, transcription));
        List<MapSide> sides = components.stream().map(each -> each.side(folder)).toList();
        for (Original each : originals) {
            if (each.path().endsWith(".map")) {
                Lacks lacks = new Lacks(each.file(), transcription);
                String path = each.path().substring(0, each.path().lastIndexOf('/') + 1);
                new MapReader(each.file(), lacks)
                        .maps(sidesBelow(sides, path))
                        .forEach(
                                (name, map) ->
                                        write(
                                                each.file(),
                                                name + ".arc",
                                                map,
                                                written,
                                                transcription));
                lacks.tell();
            }
        }
        folder.opaqueDiagram()
                .ifPresent(
                        each ->
                                write(
                                        originals.get(0).file(),
                                        "imported/Types.cd",
                                        each,
                                        written,
                                        transcription));
    }

    /** A map is about components in its folder. */
    private static List<MapSide> sidesBelow(List<MapSide> sides, String folder) {
        return sides.stream().filter(each -> each.path().startsWith(folder)).toList();
    }

    private static void convert(
            Component each,
            Folder folder,
            Map<String, SourceFile> written,
            Transcription transcription) {
        UnitContext unit = each.text().unit();
        TypeNames types = new TypeNames(unit, folder, each.lacks());
        String body =
                new ComponentWriter(unit.component(), each.text(), folder, types, each.lacks())
                        .write();
        if (each.lacks().tell()) {
            return;
        }
        String packageName = TypeNames.packageOf(unit);
        StringBuilder text = new StringBuilder();
        text.append(each.text().comments(unit));
        if (!packageName.isEmpty()) {
            text.append("package ").append(packageName).append(";\n\n");
        }
        types.imports().forEach(name -> text.append("import ").append(name).append(";\n"));
        text.append('\n');
        if (unit.component().getStart() != unit.getStart()) {
            text.append(each.text().comments(unit.component()));
        }
        text.append(body);
        String name = unit.component().name(0).getText();
        String path = Folder.qualified(packageName, name).replace('.', '/') + ".arc";
        write(each.original().file(), path, text.toString(), written, transcription);
    }

    /** Two files of one name are two models of one name, of which one is kept. */
    private static void write(
            SourceFile original,
            String path,
            String text,
            Map<String, SourceFile> written,
            Transcription transcription) {
        SourceFile other = written.putIfAbsent(path, original);
        if (other == null) {
            transcription.write(original, path, text);
        } else if (!other.text().equals(original.text())) {
            transcription.missing(
                    Lack.STRUCTURE.code(),
                    original.span(0, 0),
                    "there is another model of this name, '%s'; import one of them"
                            .formatted(other.path()));
        }
    }
}
