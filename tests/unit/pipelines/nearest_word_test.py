import unittest

from nearest_word import nearest_word

WORDS = ["--verbose", "--version", "--size", "--size-near", "--order"]


class NearestWordTest(unittest.TestCase):
    def test_the_one_with_the_fewest_errors(self):
        for word, nearest in (("--verbos", "--verbose"), ("--vresion", "--version"), ("--sise", "--size"),
                              ("--orders", "--order"), ("--vers", "--version"), ("--size-n", "--size-near")):
            self.assertEqual(nearest_word(word, WORDS), nearest)

    def test_none_is_near(self):
        self.assertEqual(nearest_word("--no-such-option", WORDS), "")
        self.assertEqual(nearest_word("-x", WORDS), "")
        self.assertEqual(nearest_word("--size", []), "")


if __name__ == "__main__":
    unittest.main()
