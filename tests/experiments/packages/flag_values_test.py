# SPDX-License-Identifier: BSD-3-Clause
"""Help texts tell what values a flag takes."""
import os
import pathlib
import unittest
import xml.etree.ElementTree as xml

from described_programs import EXECUTABLES  # also where the modules are
import flag_values
import flags_reference

# Flags of which a word is one value among others that are no words.
OF_ONE_WORD = {"sweep_duration_s", "covariances_of"}


class FlagValuesTest(unittest.TestCase):
    def test_choices_are_what_the_help_text_lists(self):
        for meaning, expected in (
                ("Matcher: fast or good_one.", ["fast", "good_one"]),
                ("Order: keep (as it is, a or b), none or by_id (Doe et al. 2015). More: x, y.",
                 ["keep", "none", "by_id"]),
                ("Error (RPE), in the\nunit of --unit: keep (poses), m (path length), or s.", ["keep", "m", "s"]),
                ("Back end: fast, the name of another one, or keep.", ["fast", "keep"])):
            default = "fast" if "fast" in meaning else "keep"
            self.assertEqual(flag_values.choices(meaning, default), expected)

    def test_a_word_that_no_list_has_is_the_only_choice(self):
        self.assertEqual(flag_values.choices("Time in s; 0: at once; auto: learned.", "auto"), ["auto"])

    def test_words_in_quotes_stand_for_a_folder_too(self):
        flag = xml.fromstring("<flag><type>string</type><meaning>Folder of a run. Alone, or 'live': this run."
                              "</meaning><default/></flag>")
        self.assertEqual(flag_values.values_of(flag), [flag_values.FOLDERS, "live"])

    def test_text_and_what_is_empty_by_default_has_no_choices(self):
        self.assertEqual(flag_values.choices("Pose x,y,theta. Empty: none.", ""), [])
        self.assertEqual(flag_values.choices("Pose x,y,theta: 0.2,0,180 looks back.", "0,0,0"), [])

    @unittest.skipUnless(EXECUTABLES, "no executables")
    def test_the_help_texts_of_flags_that_take_words_list_them(self):
        unlisted = set()
        for name in EXECUTABLES:
            executable = pathlib.Path(os.environ["GMAPPING_SPA_BINARIES"]) / name
            for flag in flags_reference.read_help(str(executable)).iter("flag"):
                if len(flag_values.values_of(flag)) == 1 and flag.findtext("default"):
                    unlisted.add(flag.findtext("name"))
        self.assertLessEqual(unlisted, OF_ONE_WORD,
                             'expected a text such as "What it is: a (...), b or c."')


if __name__ == "__main__":
    unittest.main()
