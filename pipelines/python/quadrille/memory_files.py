"""Files in memory for tools, which take paths."""
import os


class MemoryFiles:
    """Files in memory, which a process reads or writes by their paths; closed at the end."""

    def __enter__(self):
        self.descriptors, self.labels = [], {}
        return self

    def __exit__(self, *_):
        for descriptor in self.descriptors:
            os.close(descriptor)

    def new(self, data=b""):
        """The descriptor of a new file with this content, at its begin."""
        descriptor = os.memfd_create("quadrille", 0)
        self.descriptors.append(descriptor)
        view = memoryview(data)
        while view:
            view = view[os.write(descriptor, view):]
        os.lseek(descriptor, 0, os.SEEK_SET)
        return descriptor

    def path(self, data, label="the bytes"):
        """The path of a new file; messages name it by the label."""
        path = f"/proc/self/fd/{self.new(data)}"
        self.labels[path] = label
        return path

    def labelled(self, text):
        for path in sorted(self.labels, key=len, reverse=True):
            text = text.replace(path, self.labels[path])
        return text

    @staticmethod
    def content(descriptor):
        with open(f"/proc/self/fd/{descriptor}", "rb") as file:
            return file.read()


def file_name(source, files):
    """What a command line calls it: a path, or the path of its bytes in memory."""
    data = getattr(source, "data", source)
    if isinstance(data, (bytes, bytearray, memoryview)):
        return files.path(data, "the bytes" if data is source else f"the {type(source).__name__}")
    return os.fspath(source)
