package arcomat.editor.extension;

import org.w3c.dom.NodeList;
import org.xml.sax.SAXException;

import java.io.IOException;
import java.nio.file.Path;
import java.util.Set;
import java.util.TreeSet;

import javax.xml.parsers.DocumentBuilderFactory;
import javax.xml.parsers.ParserConfigurationException;

/**
 * A file by which Kate colours.
 *
 * @param words all words of its lists
 */
record KateSyntax(Set<String> words) {
    private static final Path FOLDER = Path.of("editors/kate");

    /**
     * @param name of the file, without its ending
     */
    static KateSyntax named(String name) {
        try {
            NodeList items =
                    DocumentBuilderFactory.newInstance()
                            .newDocumentBuilder()
                            .parse(FOLDER.resolve(name + ".xml").toFile())
                            .getElementsByTagName("item");
            Set<String> words = new TreeSet<>();
            for (int i = 0; i < items.getLength(); i++) {
                words.add(items.item(i).getTextContent());
            }
            return new KateSyntax(words);
        } catch (IOException | SAXException | ParserConfigurationException e) {
            throw new IllegalStateException(e);
        }
    }
}
