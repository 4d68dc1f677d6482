package arcomat.pipeline.generate;

import arcomat.brick.api.BrickTable;
import arcomat.brick.api.StubWriter;
import arcomat.pipeline.compile.ClassFiles;

import java.util.Optional;

/** The classes of leJOS NXJ, as far as a compiler has to know them. */
final class BrickClasses implements ClassFiles {
    private final BrickTable table;
    private final StubWriter stubs;

    BrickClasses(BrickTable table) {
        this.table = table;
        this.stubs = new StubWriter(table);
    }

    @Override
    public Optional<byte[]> find(String name) {
        return table.type(name).map(stubs::write);
    }

    @Override
    public boolean isPackage(String name) {
        return table.isPackage(name);
    }
}
